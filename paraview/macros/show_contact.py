"""ParaView macro. Contact arrows scaled by force and coloured by separation, of the active source's results.

Bodies are grey. Macros > Import new macro... copies this file; it needs the plugin abut_plugin.py to be loaded.
"""
try:
    from abut_paraview import views
except ImportError:
    raise RuntimeError("load the plugin abut_plugin.py first (Tools > Manage Plugins > Load New...)") from None

views.run_macro(views.show_contact)
