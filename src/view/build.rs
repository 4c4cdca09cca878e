//! Packs the page: it is a quarter of its size in the program.

use flate2::Compression;
use flate2::write::DeflateEncoder;
use std::io::{Error, Write};
use std::path::Path;

const PAGE: &str = "page/dist/index.html";

fn main() -> std::io::Result<()> {
    writeln!(std::io::stdout(), "cargo::rerun-if-changed={PAGE}")?;
    let folder = std::env::var_os("OUT_DIR").ok_or_else(|| Error::other("OUT_DIR is missing"))?;
    let mut packed = DeflateEncoder::new(Vec::new(), Compression::best());
    packed.write_all(&std::fs::read(PAGE)?)?;
    std::fs::write(Path::new(&folder).join("page.deflate"), packed.finish()?)
}
