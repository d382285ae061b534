"""Reports that people sign: one content, printed as a page for browsers and as PDF.

Everything in a report comes from the folder of its session, so that it can be made again
at any time, byte for byte.
"""
