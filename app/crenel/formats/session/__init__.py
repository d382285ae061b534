"""Recorded sessions: contact points, images and joint angles or poses, as folders."""
