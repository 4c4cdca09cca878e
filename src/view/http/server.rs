//! The server: connections on the loopback interface, each with one request.

use crate::connection;
use crate::desk::Desk;
use crate::events::{Event, Events};
use crate::shared::{Counted, Limits, Shared, random};
use std::io;
use std::net::{Ipv4Addr, SocketAddr, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::Duration;

/// A server that listens, and its secret.
#[derive(Debug)]
pub struct Server {
    listener: TcpListener,
    address: SocketAddr,
    token: String,
    limits: Limits,
}

impl Server {
    /// Listens at a port of 127.0.0.1; 0 for a free one.
    ///
    /// # Errors
    /// Fails if the port is in use, or without random numbers.
    pub fn listen(port: u16, limits: Limits) -> io::Result<Self> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
        let address = listener.local_addr()?;
        Ok(Self { listener, address, token: random()?, limits })
    }

    /// Address of the page, with the token.
    pub fn url(&self) -> String {
        format!("http://{}/?token={}", self.address, self.token)
    }

    /// Answers requests until the page has been closed for the given time.
    ///
    /// # Errors
    /// Fails if the system starts no thread.
    pub fn serve(self, desk: Arc<dyn Desk>, events: Events) -> io::Result<()> {
        let Self { listener, address, token, limits } = self;
        let shared = Arc::new(Shared::new(desk, events, token, address.port(), limits));
        let watched = shared.clone();
        std::thread::Builder::new().name("pages".to_owned()).spawn(move || wait_for_pages(&watched, address))?;
        for stream in listener.incoming() {
            if shared.ended.load(Ordering::SeqCst) {
                break;
            }
            // a connection that failed before it was accepted, or too many open files
            let Ok(stream) = stream else {
                std::thread::sleep(Duration::from_millis(10));
                continue;
            };
            accept(&shared, stream);
        }
        shared.events.send(&Event::Bye);
        Ok(())
    }
}

/// Ends the server when no page is open any more.
fn wait_for_pages(shared: &Shared, address: SocketAddr) {
    while !shared.is_idle() {
        std::thread::sleep(Duration::from_millis(200).min(shared.limits.closed / 4));
    }
    shared.ended.store(true, Ordering::SeqCst);
    // the server waits for a connection
    drop(TcpStream::connect(address));
}

/// Answers a connection in a thread of its own; rejects it beyond the bound.
fn accept(shared: &Arc<Shared>, mut stream: TcpStream) {
    // a listener at 127.0.0.1 has no other peers: a second wall
    if !stream.peer_addr().is_ok_and(|peer| peer.ip().is_loopback()) {
        return;
    }
    if stream.set_write_timeout(Some(shared.limits.body)).is_err() {
        return;
    }
    let Some(counted) = Counted::new(&shared.connections, shared.limits.connections) else {
        return connection::refuse_busy(shared, &mut stream);
    };
    let own = shared.clone();
    let answer = move || {
        connection::answer(&own, &mut stream);
        drop(counted);
    };
    drop(std::thread::Builder::new().name("request".to_owned()).spawn(answer));
}
