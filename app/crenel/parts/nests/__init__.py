"""Whether part, arm or a nest has moved, by touches of nests before and after."""
