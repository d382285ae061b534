"""The 3D view: the arm, the target, clouds and fitted shapes, shown by viser.

``scene`` is the entry point; ``view_controller`` performs the operators' commands.
"""
