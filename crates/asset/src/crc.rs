//! CRC-32 (IEEE 802.3, reflected polynomial 0xEDB88320), as in zlib, PNG and gzip.

const TABLE: [u32; 256] = table();

const fn table() -> [u32; 256] {
    let mut table = [0; 256];
    let mut i = 0;
    while i < 256 {
        let mut crc = i as u32;
        let mut bit = 0;
        while bit < 8 {
            crc = if crc & 1 == 1 { (crc >> 1) ^ 0xEDB8_8320 } else { crc >> 1 };
            bit += 1;
        }
        table[i] = crc;
        i += 1;
    }
    table
}

/// Continues the checksum `crc` (0 at the start) over `bytes`, one byte at a time, without a dependency.
#[cfg_attr(feature = "fast-checksum", allow(dead_code))]
pub(crate) fn plain(crc: u32, bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!crc, |crc, &byte| (crc >> 8) ^ TABLE[((crc ^ u32::from(byte)) & 0xFF) as usize])
}

/// Continues the checksum `crc` (0 at the start) over `bytes`, by the fastest means compiled in.
pub(crate) fn update(crc: u32, bytes: &[u8]) -> u32 {
    #[cfg(feature = "fast-checksum")]
    {
        let mut hasher = crc32fast::Hasher::new_with_initial(crc);
        hasher.update(bytes);
        hasher.finalize()
    }
    #[cfg(not(feature = "fast-checksum"))]
    plain(crc, bytes)
}

/// Checksum of the header and the section table, `table`, its own field at `field` taken as zero.
pub(crate) fn of_header(table: &[u8], field: usize) -> u32 {
    let crc = update(0, &table[..field]);
    update(update(crc, &[0; 4]), &table[field + 4..])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_check_value_of_the_catalogue() {
        assert_eq!(plain(0, b"123456789"), 0xCBF4_3926);
        assert_eq!(update(0, b"123456789"), 0xCBF4_3926);
    }

    #[test]
    fn pieces_give_the_checksum_of_the_whole() {
        assert_eq!(update(plain(0, b"1234"), b"56789"), 0xCBF4_3926);
        assert_eq!(plain(update(0, b"1234"), b"56789"), 0xCBF4_3926);
    }
}
