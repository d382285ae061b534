"""Reports for signature: one content, rendered as a page for browsers and as PDF.

Everything in a report comes from the folder of its session, so that it can be rendered again at any
time, byte for byte.
"""
