"""``crenel backup`` and ``crenel mqtt-schema``: what a station's keeper needs."""

import json


def mqtt_schema() -> None:
    """The JSON schema of what stations publish over MQTT."""
    from app.supervise.messages import schema

    print(json.dumps(schema(), indent=1, ensure_ascii=False))
