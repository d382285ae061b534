"""What crosses the wire: models of requests and answers, errors as problem+json, JSON."""
