"""Whether a text says what another one says already. Pure."""

from app.messages.message import Message, MessageList, Text, Value


def mentions(text: Text, part: Text) -> bool:
    """Whether ``part`` is the text, or stands in it.

    Of a text of an earlier version, which is an English sentence, the words decide.
    """
    if isinstance(text, str):
        return str(part).strip().rstrip(".").lower() in text.lower()
    return _contains(text, _bare(part))


def _contains(text: Value, part: Text) -> bool:
    if isinstance(text, int):
        return False
    bare = _bare(text)
    if bare == part:
        return True
    match bare:
        case Message(_, values):
            return any(_contains(value, part) for value in values.values())
        case MessageList(items):
            return any(_contains(item, part) for item in items)
    return False


def _bare(text: Text) -> Text:
    """The text without the full stop that ``sentence`` puts to it."""
    while isinstance(text, Message) and text.message_id == "sentence":
        inner = text.values["text"]
        if isinstance(inner, int):
            return text
        text = inner
    return text
