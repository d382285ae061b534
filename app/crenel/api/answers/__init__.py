"""What the routes of all subjects answer with: records that they look up, and problems."""
