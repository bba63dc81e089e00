# The server and fovea-observer as their Debian packages, with what that depends on and no compilers, as a user without
# rights; the root file system may be read-only. deploy/build_image.sh builds it without a Docker
# daemon.
ARG BASE=debian:bookworm-slim

FROM ${BASE} AS build
COPY deploy/install_dependencies.sh /tmp/
# Slim images have no folder for the manual pages that PCL's dependencies (Java) link to.
RUN mkdir -p /usr/share/man/man1 && /tmp/install_dependencies.sh
COPY . /src
# What /src is a checkout of: its history is not copied.
ARG FOVEA_COMMIT=
RUN cmake -S /src -B /build -G Ninja -DCMAKE_BUILD_TYPE=Release -DFOVEA_BUILD_TESTS=OFF \
       -DFOVEA_BUILD_CAPTURE=OFF -DFOVEA_BUILD_PCL=OFF -DFOVEA_COMMIT=${FOVEA_COMMIT} \
    && cmake --build /build --target fovea-server fovea-observer man_fovea-server man_fovea-observer changelogs \
    && cd /build && cpack -D 'CPACK_COMPONENTS_ALL=server;observer' -B /packages

FROM ${BASE}
# By apt: what is in the image stands in dpkg's list, and its licences in /usr/share/doc.
COPY --from=build /packages/*.deb /packages/
RUN apt-get update -q \
    && DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends /packages/*.deb \
    && apt-get clean && rm -rf /packages /var/lib/apt/lists/*
COPY deploy/container/fovea-server.toml /etc/fovea/
COPY deploy/container/fovea-health /usr/local/bin/
# As in the clone, whose modes follow the umask of whoever made it; the user below reads both.
RUN chmod 644 /etc/fovea/fovea-server.toml && chmod 755 /usr/local/bin/fovea-health
USER 10001:10001
EXPOSE 50051 8080
HEALTHCHECK --interval=10s --timeout=5s --start-period=10s CMD ["fovea-health"]
STOPSIGNAL SIGTERM
ENTRYPOINT ["fovea-server", "--config", "/etc/fovea/fovea-server.toml"]
