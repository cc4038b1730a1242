"""What abut shows in ParaView: algorithms, which need VTK and numpy but not ParaView, and `views`, which needs it."""
