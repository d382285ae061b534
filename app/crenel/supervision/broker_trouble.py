"""Why a broker cannot be reached, and what helps."""

import ssl

import aiomqtt
from aiomqtt.exceptions import MqttConnectError

from crenel.errors import OperationError
from crenel.messages.message import Text, message


def explain_failure(error: Exception, tls: bool) -> tuple[Text, Text]:
    """The reason why a connection to a broker failed or ended, and its remedy.

    Args:
        error: of the client, which keeps that of the network as its context.
        tls: whether the connection is encrypted.
    """
    if isinstance(error, OperationError):
        return error.text, error.remedy
    reason = str(error)
    if isinstance(error, MqttConnectError):
        return reason, message("check-broker-user-and-password")
    cause = error.__context__ if isinstance(error, aiomqtt.MqttError) else error
    if isinstance(cause, ssl.SSLCertVerificationError):
        return reason, message("check-broker-certificate")
    if isinstance(cause, ssl.SSLError) or (tls and isinstance(cause, ConnectionResetError)):
        return message("broker-speaks-no-tls", reason=reason), message("check-broker-tls-off")
    # asyncio's own end of a wait says nothing; one of the network has words or a number
    if not tls and isinstance(cause, TimeoutError) and not cause.args:
        return message("broker-gives-no-answer", reason=reason), message("check-broker-tls-on")
    return reason, message("check-broker-runs")
