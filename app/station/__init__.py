"""The live station: devices, scanning, preview and the 3D view.

``devices`` own a thread for each device, ``scan`` turns frames into recorded points, ``preview``
shows the live image, ``view3d`` shows the cloud. ``bus`` carries state between threads and to the
browsers, ``control_lease`` says who has control, ``jobs`` runs what takes long.
"""
