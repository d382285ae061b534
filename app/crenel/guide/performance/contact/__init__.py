"""The contact tests of ASME B89.4.22 in a performance test: sphere, seats, ball bar."""
