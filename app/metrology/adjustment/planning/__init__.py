"""Which pose and which contact points would reduce the uncertainty most."""
