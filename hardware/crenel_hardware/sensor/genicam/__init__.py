"""The ``genicam`` driver: cameras with GigE Vision or USB3 Vision, through the library Aravis."""
