"""What Crenel says, in other languages than the one it is written in."""
