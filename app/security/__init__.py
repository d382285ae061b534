"""Who may do what: sign-in, permissions, and what slows strangers down.

``permissions`` has a line for every route and message; ``app.api.access.authorization`` applies it.
"""
