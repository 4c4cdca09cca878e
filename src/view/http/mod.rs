//! The server: connections, requests, answers.

pub(super) mod answer;
pub(super) mod connection;
pub(super) mod events;
pub(super) mod refusals;
pub(super) mod request;
pub(super) mod routes;
pub(super) mod server;
