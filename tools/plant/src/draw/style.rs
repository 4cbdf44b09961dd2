//! Colours and strokes: every symbol is drawn with these classes and no others.

/// The style sheet of a picture.
pub(super) const STYLE: &str = "\
text{font-family:Inter,'Liberation Sans',Arial,'DejaVu Sans',sans-serif;fill:#243447;font-size:12px}\
.title{font-size:18px;font-weight:600}.time{font-size:14px;fill:#5b6b7b;text-anchor:end}\
.label{font-size:12px;text-anchor:middle;fill:#3b4b5c}.small{font-size:10px;text-anchor:middle;fill:#5b6b7b}\
.tag{font-size:11px;font-weight:600;fill:#243447}.mid{text-anchor:middle}\
.digits{font-size:20px;font-weight:600;text-anchor:middle;fill:#b6f2c4}\
.warn{font-size:12px;font-weight:700;text-anchor:middle;fill:#c62828}\
.paper{fill:#fff}.sheet{fill:#f7f9fb}.plate{fill:#e4eaf0;stroke:#b5c1cd;stroke-width:1.5}\
.ink{fill:none;stroke:#243447;stroke-width:2;stroke-linecap:round;stroke-linejoin:round}\
.thin{fill:none;stroke:#5b6b7b;stroke-width:1.2;stroke-linecap:round}\
.dash{fill:none;stroke:#5b6b7b;stroke-width:1.2;stroke-dasharray:4 3}\
.solid{fill:#243447}.soft{fill:#8b99a8}\
.body{fill:#fff;stroke:#243447;stroke-width:2;stroke-linejoin:round}\
.metal{fill:#d6dee6;stroke:#5b6b7b;stroke-width:1.5;stroke-linejoin:round}\
.dark{fill:#4a5a6b;stroke:#2c3947;stroke-width:1.5}.deep{fill:#26323e}\
.shade{fill:#b9c5d0}.rim{fill:#c7d1db;stroke:#7b8997;stroke-width:1.5}\
.water{fill:#58a9e8}.wave{fill:#8cc8f5}.mixed{fill:#7a6fd0}\
.pipe{fill:none;stroke:#9fb0c0;stroke-width:9;stroke-linejoin:round;stroke-linecap:round}\
.pipe-in{fill:none;stroke:#e3e9ef;stroke-width:5;stroke-linejoin:round;stroke-linecap:round}\
.flow{fill:none;stroke:#58a9e8;stroke-width:5;stroke-linejoin:round;stroke-linecap:round}\
.wire{fill:none;stroke:#243447;stroke-width:2;stroke-linejoin:round}\
.hot{fill:none;stroke:#e0452f;stroke-width:3;stroke-linejoin:round}\
.floor{fill:none;stroke:#8b99a8;stroke-width:3}.frame{fill:#f0f4f8;stroke:#c2ccd6;stroke-width:1.5}\
.green-on{fill:#2fbf5f;stroke:#167a38;stroke-width:1.5}.green-off{fill:#6f9a7d;stroke:#4b6d57;stroke-width:1.5}\
.red-on{fill:#f0383b;stroke:#a31518;stroke-width:1.5}.red-off{fill:#a96c6e;stroke:#7c484a;stroke-width:1.5}\
.yellow-on{fill:#ffc61a;stroke:#a97c00;stroke-width:1.5}.yellow-off{fill:#b09a62;stroke:#7e6d42;stroke-width:1.5}\
.blue-on{fill:#3d8bff;stroke:#1452ad;stroke-width:1.5}.blue-off{fill:#7088ad;stroke:#4c607f;stroke-width:1.5}\
.white-on{fill:#fffbe0;stroke:#a99f6d;stroke-width:1.5}.white-off{fill:#c6c8c8;stroke:#8b8f92;stroke-width:1.5}\
.glow{opacity:.35}.shine{fill:#fff;opacity:.35}\
.skin{fill:#f3c7a0;stroke:#9a6b45;stroke-width:1.2}.cloth{fill:#3f7fbf;stroke:#27537f;stroke-width:1.2}\
.car{fill:#4479c4;stroke:#274a7d;stroke-width:1.5}.glass{fill:#cfe6f7;stroke:#274a7d;stroke-width:1}\
.road{fill:#59636e}.mark{fill:#f4f6f8}.kerb{fill:#c5ced6}\
.plastic{fill:#e8a33d;stroke:#9a6718;stroke-width:1.5}.steel{fill:#9fb4c8;stroke:#50657a;stroke-width:1.5}\
.bottle{fill:#eef6fb;stroke:#5d7f99;stroke-width:1.5}.heat{fill:#f2643d}.cool{fill:#dce7f0}";
