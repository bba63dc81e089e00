# The server and the command line without compilers, as a user without rights; the root file system
# may be read-only. deploy/build_image.sh builds it without a Docker daemon.
ARG BASE=debian:bookworm-slim

FROM ${BASE} AS build
COPY deploy/install_dependencies.sh /tmp/
RUN /tmp/install_dependencies.sh
COPY . /src
# What /src is a checkout of: its history is not copied.
ARG FOVEA_COMMIT=
RUN cmake -S /src -B /build -G Ninja -DCMAKE_BUILD_TYPE=Release -DFOVEA_BUILD_TESTS=OFF \
       -DFOVEA_BUILD_CAPTURE=OFF -DFOVEA_COMMIT=${FOVEA_COMMIT} \
    && cmake --build /build --target fovea-server fovea \
    && strip /build/server/fovea-server /build/client/cli/fovea
# The libraries that the two need, and what these need, as ldd names them: Debian's packages of
# OpenCV would bring far more.
RUN mkdir -p /root-fs/usr/local/bin /root-fs/usr/local/lib/fovea \
    && cp /build/server/fovea-server /build/client/cli/fovea /root-fs/usr/local/bin/ \
    && ldd /root-fs/usr/local/bin/* | awk '$2 == "=>" && $3 ~ /^\// {print $3}' | sort -u \
       | grep -vE '/(libc|libm|libdl|librt|libpthread|ld-linux.*)\.so' \
       | xargs -I{} cp -L {} /root-fs/usr/local/lib/fovea/

FROM ${BASE}
COPY --from=build /root-fs/ /
COPY --from=build /src/LICENSE /usr/share/doc/fovea/LICENSE
RUN echo /usr/local/lib/fovea > /etc/ld.so.conf.d/fovea.conf && ldconfig
USER 10001:10001
EXPOSE 50051
HEALTHCHECK --interval=10s --timeout=5s CMD ["fovea", "health"]
STOPSIGNAL SIGTERM
ENTRYPOINT ["fovea-server"]
