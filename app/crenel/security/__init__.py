"""Access control: sign-in, permissions, and limits for clients without an account.

``permissions`` has a line for every route and message; ``crenel.api.access.authorization`` applies
it.
"""
