"""Who may do what: signing in, accounts, and the check of every request."""
