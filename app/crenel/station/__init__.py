"""The live station: devices, scanning, preview and the 3D view.

``devices`` have one thread per device, ``scan`` turns frames into recorded points, ``preview``
shows the live image, ``view3d`` shows the cloud. ``bus`` carries state between threads and to the
browsers, ``control_lease`` manages control, ``jobs`` runs long work.
"""
