#!/usr/bin/python3
"""Write two synthetic tool surfaces as X3P files (ISO 25178-72).

  polished_tool.x3p  polished rake face: fine grooves along y, Rz 0.29 um along
                     x (chip flow) and 0.26 um along y
  blasted_tool.x3p   wet-air-blasted rake face: isotropic dimples, Rz 0.96 um

Both carry what a microscope adds: tilt, noise, and a few missing points where
the flanks are steep. Rz is the mean peak-to-valley height of five sections
(ISO 4287) of the rows and columns after removal of the plane, unfiltered, and
the heights are scaled until its mean over all rows (and columns) is the value
above. The same seed gives the same heights.

Usage: tools/make_surfaces.py [FOLDER]   (default: parameter_files/surfaces)
Needs numpy.
"""

import hashlib
import pathlib
import sys
import zipfile

import numpy as np

NX, NY = 320, 320
SPACING = 0.5e-6    # m
INCREMENT = 1.0e-10  # m, of the 16-bit heights


def remove_plane(z):
    y, x = np.mgrid[0:z.shape[0], 0:z.shape[1]]
    valid = np.isfinite(z)
    terms = np.stack([np.ones_like(x), x, y], axis=-1).astype(float)
    plane = np.linalg.lstsq(terms[valid], z[valid], rcond=None)[0]
    return z - terms @ plane


def mean_rz(z):
    """Mean over the rows of the mean height of five sections."""
    sections = np.array_split(z, 5, axis=1)
    return np.mean([np.nanmax(s, axis=1) - np.nanmin(s, axis=1)
                    for s in sections])


def waves(random, length_x, length_y):
    """Gaussian field of unit variance with the given correlation lengths [m]."""
    kx = 2 * np.pi * np.fft.fftfreq(NX, SPACING)
    ky = 2 * np.pi * np.fft.fftfreq(NY, SPACING)[:, None]
    spectrum = np.fft.fft2(random.normal(size=(NY, NX)))
    spectrum *= np.exp(-((kx * length_x) ** 2 + (ky * length_y) ** 2) / 4)
    field = np.real(np.fft.ifft2(spectrum))
    return (field - field.mean()) / field.std()


def scratch(random, z, depth):
    """A narrow groove of Gaussian section, nearly along y."""
    y, x = np.mgrid[0:NY, 0:NX] * SPACING
    angle = random.normal(0, 0.12)
    centre = random.uniform(0, NX * SPACING)
    distance = (x - centre) * np.cos(angle) + (y - y.mean()) * np.sin(angle)
    width = random.uniform(0.5e-6, 1.2e-6)
    z -= depth * np.exp(-((distance / width) ** 2))


def polished(random):
    """Heights of unit scale: an even surface and the lay of the polishing."""
    even = waves(random, 2.5e-6, 2.5e-6) + 0.6 * waves(random, 9e-6, 9e-6)
    lay = waves(random, 1.6e-6, 40e-6)
    for _ in range(14):
        scratch(random, lay, random.uniform(0.5, 2.0))
    return even, lay


def blasted(random):
    """Heights of unit scale: overlapping dimples with raised rims."""
    z = 0.15 * waves(random, 12e-6, 12e-6)
    y, x = np.mgrid[0:NY, 0:NX] * SPACING
    for _ in range(1500):
        radius = np.clip(random.lognormal(np.log(3.2e-6), 0.35), 1.5e-6, 9e-6)
        depth = 0.3 * (radius / 3e-6) * random.uniform(0.5, 1.3)
        cx = random.uniform(-radius, NX * SPACING + radius)
        cy = random.uniform(-radius, NY * SPACING + radius)
        r2 = ((x - cx) ** 2 + (y - cy) ** 2) / radius**2
        near = r2 < 4
        # A ball leaves a cap; older dimples under it are flattened.
        bowl = np.clip(1 - r2[near], 0, None)
        rim = 0.25 * np.exp(-((np.sqrt(r2[near]) - 1.1) / 0.25) ** 2)
        level = z[near].mean()
        z[near] = np.where(r2[near] < 1,
                           level + 0.35 * (z[near] - level) - depth * bowl,
                           z[near]) + depth * rim
    return z + 0.05 * waves(random, 1e-6, 1e-6)


def lose_points(random, z):
    """A few clusters of missing points, most of them on steep flanks."""
    slope = np.hypot(*np.gradient(z))
    steep = np.argwhere(slope > np.quantile(slope, 0.995))
    for row, column in steep[random.choice(len(steep), 40, replace=False)]:
        z[row, column:column + random.randint(1, 4)] = np.nan
    for _ in range(40):
        z[random.randint(NY), random.randint(NX)] = np.nan


def write_x3p(path, z, comment):
    """16-bit heights with an offset; missing points in valid.bin."""
    offset = 0.5 * (np.nanmin(z) + np.nanmax(z))
    raw = np.nan_to_num(np.rint((z - offset) / INCREMENT)).astype("<i2")
    data = raw.tobytes()
    valid = np.packbits(np.isfinite(z).ravel(), bitorder="little").tobytes()
    md5 = lambda content: hashlib.md5(content).hexdigest()
    axis = ("<AxisType>{}</AxisType><DataType>{}</DataType>"
            "<Increment>{!r}</Increment><Offset>{!r}</Offset>").format
    main = f"""<?xml version="1.0" encoding="UTF-8"?>
<p:ISO5436_2 xmlns:p="http://www.opengps.eu/2008/ISO5436_2">
  <Record1>
    <Revision>ISO5436 - 2000</Revision>
    <FeatureType>SUR</FeatureType>
    <Axes>
      <CX>{axis("I", "D", SPACING, 0.0)}</CX>
      <CY>{axis("I", "D", SPACING, 0.0)}</CY>
      <CZ>{axis("A", "I", INCREMENT, float(offset))}</CZ>
    </Axes>
  </Record1>
  <Record2>
    <Date>1970-01-01T00:00:00</Date>
    <Creator>tools/make_surfaces.py of Asperity</Creator>
    <Instrument><Manufacturer>not available</Manufacturer><Model>not available</Model><Serial>not available</Serial><Version>not available</Version></Instrument>
    <CalibrationDate>1970-01-01T00:00:00</CalibrationDate>
    <ProbingSystem><Type>NonContacting</Type><Identification>not available</Identification></ProbingSystem>
    <Comment>{comment}</Comment>
  </Record2>
  <Record3>
    <MatrixDimension><SizeX>{NX}</SizeX><SizeY>{NY}</SizeY><SizeZ>1</SizeZ></MatrixDimension>
    <DataLink>
      <PointDataLink>bindata/data.bin</PointDataLink>
      <MD5ChecksumPointData>{md5(data)}</MD5ChecksumPointData>
      <ValidPointsLink>bindata/valid.bin</ValidPointsLink>
      <MD5ChecksumValidPoints>{md5(valid)}</MD5ChecksumValidPoints>
    </DataLink>
  </Record3>
  <Record4><ChecksumFile>md5checksum.hex</ChecksumFile></Record4>
</p:ISO5436_2>
""".encode()
    checksum = f"{md5(main)} *main.xml\n".encode()
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, content in (("main.xml", main),
                              ("bindata/data.bin", data),
                              ("bindata/valid.bin", valid),
                              ("md5checksum.hex", checksum)):
            # A fixed date makes equal content give equal files.
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)


def finish(random, path, z, tilt, rz, comment):
    """Scale to the wanted Rz (both directions), tilt, lose points, write."""
    z = z.copy()
    lose_points(random, z)
    z = remove_plane(z)
    z *= rz / np.mean([mean_rz(z), mean_rz(z.T)])
    y, x = np.mgrid[0:NY, 0:NX] * SPACING
    write_x3p(path, z + tilt[0] * x + tilt[1] * y, comment)
    flat = remove_plane(z)
    print(f"{path}: Rz along x {mean_rz(flat) * 1e6:.4f} um, "
          f"along y {mean_rz(flat.T) * 1e6:.4f} um, "
          f"Sq {np.nanstd(flat) * 1e6:.4f} um, "
          f"missing {np.isnan(z).mean() * 100:.2f} %")


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else
                          pathlib.Path(__file__).parent.parent /
                          "parameter_files" / "surfaces")
    folder.mkdir(parents=True, exist_ok=True)

    # RandomState promises the same stream in every version of numpy.
    random = np.random.RandomState(29)
    even, lay = polished(random)
    even += 0.05 * waves(random, 0.3e-6, 0.3e-6)
    low, high = 0.0, 3.0
    for _ in range(40):  # how much lay makes the ratio of Rz 0.29 : 0.26
        share = 0.5 * (low + high)
        z = remove_plane(even + share * lay)
        if mean_rz(z) / mean_rz(z.T) < 0.29 / 0.26:
            low = share
        else:
            high = share
    finish(random, folder / "polished_tool.x3p", even + share * lay,
           (2e-3, -1e-3), 0.275e-6,
           "Synthetic polished tool surface, Rz 0.29 um along x, 0.26 um along y")

    random = np.random.RandomState(96)
    z = blasted(random) + 0.02 * waves(random, 0.3e-6, 0.3e-6)
    finish(random, folder / "blasted_tool.x3p", z, (-3e-3, 2e-3), 0.96e-6,
           "Synthetic wet-air-blasted tool surface with dimples, Rz 0.96 um")


if __name__ == "__main__":
    main()
