"""Signing in with the accounts of a plant, by OpenID Connect.

``provider`` is what a server uses: it begins and finishes a sign-in. ``settings`` is the table
``[sign_in]``. The package knows neither the station nor its store, so that every server of Crenel
can use it.
"""
