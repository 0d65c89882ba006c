# acmap's tools and its Python module on Debian 12.
#   docker build -t acmap .
#   docker run --rm -v "$PWD":/work acmap pcl_dewall_surface cloud.pcd mesh.ply
FROM debian:bookworm-slim AS build
WORKDIR /acmap
# The distribution's packages change less often than the sources: a layer of their own.
COPY cmake/bootstrap cmake/packages.txt cmake/
RUN sh cmake/bootstrap deps build package python
COPY . .
RUN sh cmake/bootstrap packages

FROM debian:bookworm-slim
COPY --from=build /acmap/build/package/*.deb /packages/
RUN rm /packages/libacmap-dev_*.deb \
 && apt-get update \
 && apt-get install -y --no-install-recommends /packages/*.deb xvfb xauth libgl1-mesa-dri \
 && rm -rf /packages /var/lib/apt/lists/*
WORKDIR /work
CMD ["bash"]
