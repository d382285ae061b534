"""What acts in the operator's place: the simulated operator; pictures at each rest of a robot."""
