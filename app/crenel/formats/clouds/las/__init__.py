"""LAS, LAZ and COPC, through laspy, lazrs and copclib."""
