# The MQTT broker of several stations: Debian's own.
FROM debian:bookworm-slim
# hadolint ignore=DL3008
RUN apt-get update \
    && apt-get install -y --no-install-recommends mosquitto \
    && rm -rf /var/lib/apt/lists/* \
    && useradd --uid 1000 broker \
    && install -d -o broker -g broker /data
USER 1000:1000
VOLUME /data
EXPOSE 1883
CMD ["mosquitto", "-c", "/etc/mosquitto/mosquitto.conf"]
