"""ParaView macro. Deformed particles coloured by von Mises stress, of the active source's result folder.

Macros > Import new macro... copies this file; it needs the plugin abut_plugin.py to be loaded.
"""
try:
    from abut_paraview import views
except ImportError:
    raise RuntimeError("load the plugin abut_plugin.py first (Tools > Manage Plugins > Load New...)") from None

views.run_macro(views.show_stress)
