"""A simulated GigE Vision camera: control, stream and description, on real sockets."""
