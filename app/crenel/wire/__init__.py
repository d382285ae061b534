"""Models of what is sent between server and browser: requests, answers, errors as problem+json,
JSON."""
