# docker build -t etalon .
# docker run --rm --user "$(id -u):$(id -g)" -v "$PWD:/work" etalon run my-campaign
FROM rust:1-bookworm AS build
WORKDIR /etalon
COPY . .
RUN cargo build --release --locked

FROM debian:bookworm-slim
COPY --from=build /etalon/target/release/etalon /usr/bin/etalon
COPY --from=build /etalon/LICENSE /usr/share/doc/etalon/copyright
WORKDIR /work
ENTRYPOINT ["etalon"]
CMD ["--help"]
