"""Access control: sign-in, accounts, and the check of every request."""
