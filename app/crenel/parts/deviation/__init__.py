"""How far a scan deviates from the nominal shape, where, and how sure that is."""
