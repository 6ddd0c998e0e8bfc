#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reads a Multi-Triangulation file by the tables of Documentation/file-format.md alone.

usage: read_model.py MODEL.bmt DUMP

DUMP gets, for every arc in order: counts of points, ids, wedges of the table and triangles (u32 each), then points (i32),
ids (u64), the wedge table (u32), triangles (u32), then the columns of all arrays as they are in memory; at the end the
blobs. The libraries that the format names are called directly: LZ4, zstd, xxHash.
"""
import bisect
import ctypes
import ctypes.util
import math
import struct
import sys

MASK = 0xFFFFFFFF
AHEAD, NEW, SECOND, BEHIND, NAMED, NOTHING, TAKEN, OTHER = range(8)  # steps, and what else the last one may have been
NAME, WALK = range(2)  # numbers among the names


def steps_of(ahead_open, behind_open, last):
    """What so many ones mean."""
    if not ahead_open:
        return (NOTHING, NEW, NAMED, BEHIND, SECOND) if behind_open else (NOTHING, NEW, NAMED, SECOND)
    if not behind_open:
        return (NOTHING, NEW, AHEAD, NAMED, SECOND)
    return {AHEAD: (NEW, AHEAD, NOTHING, NAMED, BEHIND, SECOND),
            NEW: (NEW, AHEAD, SECOND, NOTHING, NAMED, BEHIND),
            TAKEN: (NEW, BEHIND, AHEAD, NAMED, NOTHING, SECOND),
            OTHER: (AHEAD, NEW, BEHIND, NAMED, SECOND, NOTHING)}[last]


def library(name, fallback):
    return ctypes.CDLL(ctypes.util.find_library(name) or fallback)


XXHASH = library("xxhash", "libxxhash.so.0")
XXHASH.XXH3_64bits.restype = ctypes.c_uint64
XXHASH.XXH3_64bits.argtypes = [ctypes.c_char_p, ctypes.c_size_t]
LZ4 = library("lz4", "liblz4.so.1")
ZSTD = library("zstd", "libzstd.so.1")
ZSTD.ZSTD_decompress.restype = ctypes.c_size_t
ZSTD.ZSTD_decompress.argtypes = [ctypes.c_char_p, ctypes.c_size_t, ctypes.c_char_p, ctypes.c_size_t]


def require(condition, what):
    if not condition:
        raise SystemExit(f"read_model.py: {what}")


def align(size, to=16):
    return (size + to - 1) // to * to


def check(data, checksum, what):
    require(XXHASH.XXH3_64bits(data, len(data)) == checksum, f"the checksum of {what} is wrong")


def decompress(codec, data, size):
    if size == 0:
        return b""
    out = ctypes.create_string_buffer(size)
    if codec == 1:
        done = LZ4.LZ4_decompress_safe(data, out, len(data), size)
    else:
        done = ZSTD.ZSTD_decompress(out, size, data, len(data))
    require(done == size, "a block cannot be decompressed")
    return out.raw[:size]


class Stream:
    """Numbers and bytes one after the other."""

    def __init__(self, data):
        self.data = data
        self.at = 0

    def take(self, count):
        require(self.at + count <= len(self.data), "a block is too short")
        self.at += count
        return self.data[self.at - count:self.at]

    def unpack(self, what):
        return struct.unpack("<" + what, self.take(struct.calcsize("<" + what)))

    def number(self):
        value = shift = 0
        while True:
            byte = self.take(1)[0]
            value |= (byte & 0x7F) << shift
            shift += 7
            if byte < 0x80:
                return value

    def string(self):
        return self.take(self.unpack("I")[0])

    def mapping(self, value):
        return {self.string(): value() for _ in range(self.unpack("I")[0])}


def bits(data, count):
    return [data[i // 8] >> (i % 8) & 1 for i in range(count)]


def signed(value, width=32):
    value &= (1 << width) - 1
    return value - (1 << width) if value >> (width - 1) else value


def unzigzag(code, width=32):
    return ((code >> 1) ^ -(code & 1)) & ((1 << width) - 1)


PAGES, METADATA, NODES, ARCS, ENTERING, SECTIONS, MEASURES, RANGES, DISTANCES = range(1, 10)  # types of blocks
PAGE = 65536
BLOB = 0x8000
FINEST = b"finest"


class Header:
    """The header and its table of blocks; all pages are verified at once."""

    def __init__(self, data):
        require(data[:8] == bytes([0x89, 0x42, 0x4D, 0x54, 0x0D, 0x0A, 0x1A, 0x0A]), "no Multi-Triangulation file")
        (version, size, file_size, self.pages_at, self.sections_at, page_checksum, page, blocks,
         reserved) = struct.unpack_from("<IIQQQQIIQ", data, 8)
        require(version == 6 and file_size == len(data), "another version, or truncated")
        require(size == max(256, align(72 + 24 * blocks)) and page == PAGE and reserved == 0, "an impossible header")
        check(data[:size - 8], struct.unpack_from("<Q", data, size - 8)[0], "the header")
        require(not any(data[64 + 24 * blocks:size - 8]), "the header is not padded with zeros")
        self.blocks = {}
        for i in range(blocks):
            kind, flags, offset, length = struct.unpack_from("<IIQQ", data, 64 + 24 * i)
            require(kind not in self.blocks and flags <= 1 and offset % 16 == 0, "an impossible block")
            require(PAGES <= kind <= DISTANCES or flags == 0, f"a block of type {kind} must be known")
            require(kind == PAGES or self.pages_at <= offset <= offset + length <= self.sections_at, "a block out of place")
            self.blocks[kind] = (offset, length)
        pages = range(self.pages_at, self.sections_at, PAGE)
        require(self.blocks[PAGES] == (size, 8 * len(pages)) and self.pages_at == size + align(8 * len(pages))
                and self.sections_at % 4096 == 0, "the page block is out of place")
        check(data[size:self.pages_at], page_checksum, "the page block")
        for i, at in enumerate(pages):
            checksum = struct.unpack_from("<Q", data, size + 8 * i)[0]
            check(data[at:min(at + PAGE, self.sections_at)], checksum, f"page {i}")
        self.check_padding(data)

    def check_padding(self, data):
        ends = sorted((offset, offset + length) for offset, length in self.blocks.values())
        at = ends[0][0]
        for offset, end in ends + [(self.sections_at, self.sections_at)]:
            require(offset >= at and not any(data[at:offset]), "blocks overlap, or are not padded with zeros")
            at = end

    def records(self, data, kind, layout):
        offset, length = self.blocks.get(kind, (0, 0))
        size = struct.calcsize("<" + layout)
        require(length % size == 0, "a block of broken records")
        return [struct.unpack_from("<" + layout, data, offset + i) for i in range(0, length, size)]


class Array:
    def __init__(self, stream):
        self.name = stream.string()
        self.type, self.components, self.attribute, self.tuple_size = stream.unpack("iiiI")
        self.association, self.resampling, self.role, _ = stream.unpack("BBBB")
        self.component_names = [stream.string() for _ in range(stream.unpack("I")[0])]
        self.properties = stream.mapping(stream.string)
        self.ranges = [stream.unpack("dd") for _ in range(self.components)]


class Model:
    def __init__(self, data):
        self.data = data
        self.header = head = Header(data)
        self.nodes = head.records(data, NODES, "7d4I")
        self.arcs = head.records(data, ARCS, "6I6i3fffBBHIIIIQ")
        self.entering = [i for i, in head.records(data, ENTERING, "I")]
        self.read_metadata()
        self.sections = head.records(data, SECTIONS, "QIBBH")
        if self.measures:
            self.measure_values = head.records(data, MEASURES, f"{len(self.measures)}d")
            require(len(self.measure_values) == len(self.nodes), "measures of other nodes")
        if self.columns:
            self.range_values = head.records(data, RANGES, f"{2 * len(self.columns)}d")
            require(len(self.range_values) == len(self.arcs), "ranges of other arcs")
        if DISTANCES in head.blocks:
            self.distances = head.records(data, DISTANCES, "2f")
            require(len(self.distances) == len(self.arcs), "distances of other arcs")
            require(all(0 <= d < float("inf") for both in self.distances for d in both), "impossible distances")
        self.check_graph()
        self.check_sections()
        self.check_figures()

    def read_metadata(self):
        offset, length = self.header.blocks[METADATA]
        stream = Stream(self.data[offset:offset + length])
        (self.step, *self.origin, self.shift) = stream.unpack("d3qd")
        self.input_counts = stream.unpack("4Q")
        self.finest_triangles = stream.unpack("Q")[0]
        self.box = stream.unpack("6i")
        self.levels, self.shared_borders, arrays, blobs, measures, columns = stream.unpack("6I")
        self.refinement, self.has_frame = stream.unpack("BB")
        require(self.refinement <= 1 and self.has_frame <= 1 and not any(stream.take(2)), "impossible metadata")
        self.largest_wedges = stream.unpack("I")[0]
        self.frame = stream.unpack("16d")
        self.arrays = [Array(stream) for _ in range(arrays)]
        self.blobs = [(stream.string(), stream.string(), stream.mapping(stream.string), stream.unpack("Q")[0])
                      for _ in range(blobs)]
        self.measures = [stream.string() for _ in range(measures)]
        self.columns = [stream.unpack("II") for _ in range(columns)]
        self.crs, self.units = stream.string(), stream.string()
        self.settings = stream.mapping(stream.string)
        self.input_report = stream.mapping(lambda: stream.unpack("q")[0])
        self.blocked = stream.mapping(lambda: stream.unpack("q")[0])
        require(stream.at == length, "metadata of another length")

    def check_graph(self):
        """That the nodes' runs and the entering table are those of the arcs."""
        require(self.entering == sorted(range(len(self.arcs)), key=lambda i: (self.arcs[i][1], i)), "another entering table")
        require(all(a[:2] <= b[:2] for a, b in zip(self.arcs, self.arcs[1:])), "arcs out of order")
        leaving, entering = ([arc[0] for arc in self.arcs], sorted(arc[1] for arc in self.arcs))
        for n, node in enumerate(self.nodes):
            require(node[9] == bisect.bisect_left(leaving, n), f"node {n} has another first arc")
            require(node[10] == bisect.bisect_left(entering, n), f"node {n} has another first entry")

    def check_sections(self):
        """Places follow each other; self.places[arc] maps classes to (offset, section)."""
        section, at = len(self.blobs), self.header.sections_at
        self.places = []
        for i, arc in enumerate(self.arcs):
            kind, flags, count, first, offset = arc[17], arc[18], arc[19], arc[20], arc[24]
            require(kind == 0 and flags == 0 and not any(arc[21:24]), f"arc {i} is of another kind")
            require(first == section and offset == at and (count == 0) == (arc[2:5] == (0, 0, 0)), f"sections of arc {i}")
            classes = [self.sections[section + k][4] for k in range(count)]
            require(classes == sorted(set(classes)) and classes[:1] in ([], [0]), f"classes of arc {i}")
            self.places.append({})
            for number in classes:
                self.places[-1][number] = (at, self.sections[section])
                at += align(self.sections[section][1])
                section += 1
        require(section == len(self.sections), "sections of no arc")
        for i, blob in enumerate(self.blobs):
            require(blob[3] == at and self.sections[i][2:] == (0, 0, BLOB), f"blob {i} is out of place")
            at += align(self.sections[i][1])
        require(at == len(self.data), "the sections do not account for all bytes")

    def check_figures(self):
        finest = [arc for arc in self.arcs if self.refinement == 1 or arc[1] == len(self.nodes) - 1]
        require(self.finest_triangles == sum(arc[2] for arc in finest), "another number of finest triangles")
        require(self.levels == max((self.nodes[arc[1]][7] + 1 for arc in self.arcs), default=0), "other levels")
        require(self.largest_wedges == max((arc[4] for arc in self.arcs), default=0), "another largest patch")
        boxes = [arc[6:12] for arc in self.arcs if arc[6] <= arc[7]]
        if boxes:
            box = tuple((max if i % 2 else min)(b[i] for b in boxes) for i in range(6))
            require(self.box == box, "another box")

    def get(self, at, section, name):
        checksum, size, codec = section[:3]
        check(self.data[at:at + align(size)], checksum, name)
        return codec, self.data[at:at + size]

    def section(self, arc, number):
        """Codec and bytes; no bytes where there is no such section."""
        if number not in self.places[arc]:
            return 0, b""
        return self.get(*self.places[arc][number], f"section {number} of arc {arc}")


class NameReader:
    def __init__(self, data):
        self.parameters, self.bits, self.size = data[:2], int.from_bytes(data[2:], "little"), len(data[2:])
        self.at = 0

    def get(self, kind):
        parameter = self.parameters[kind]
        ones = 0
        while self.bits >> self.at & 1:
            ones += 1
            self.at += 1
        value = ones << parameter | self.bits >> self.at + 1 & ((1 << parameter) - 1)
        self.at += 1 + parameter
        return value

    def is_at_end(self):
        return self.size == (self.at + 7) // 8


class Waiting:
    def __init__(self, far, across=None, owner=None, is_open=True):
        self.far, self.across, self.owner, self.is_open = far, across, owner, is_open


class Front:
    """The present gate [rear, hinge, across, owner] or None, and the waiting ones ahead and behind, nearest first."""

    def __init__(self):
        self.present = None

    def start(self, t, owner):
        self.forward, self.last, self.joined = True, AHEAD, 0
        self.present = [t[0], t[1], t[2], owner]
        self.sides = [[Waiting(t[2], t[0], owner), Waiting(t[0], t[1], owner)], []]
        self.settle()

    def is_open(self, side):
        return bool(self.sides[side]) and self.sides[side][0].is_open

    def ends(self):
        rear, hinge = self.present[:2]
        return (rear, hinge) if self.forward else (hinge, rear)

    def walk(self, walk):
        side, count = self.sides[walk % 2 == 0], (walk + 1) // 2
        require(count <= len(side), "a walk to no gate")
        return side[count - 1].far

    def turn(self):
        self.forward = not self.forward
        self.sides.reverse()
        self.present[0], self.present[1] = self.present[1], self.present[0]
        self.joined = 0

    def split(self, vertex, owner, last):
        rear, hinge = self.present[:2]
        self.sides[1].insert(0, Waiting(rear, hinge, owner))
        self.present, self.last = [vertex, hinge, rear, owner], last
        self.settle()

    def split_behind(self, vertex, owner):
        rear, hinge = self.present[:2]
        self.sides[0].insert(0, Waiting(hinge, rear, owner))
        self.present, self.last = [rear, vertex, hinge, owner], OTHER
        self.turn()
        self.settle()

    def join_ahead(self, owner):
        rear, hinge = self.present[:2]
        self.present, self.last = [rear, self.sides[0].pop(0).far, hinge, owner], AHEAD
        self.joined += 1
        self.settle()

    def join_behind(self, owner):
        rear, hinge = self.present[:2]
        self.present, self.last = [self.sides[1].pop(0).far, hinge, rear, owner], OTHER
        self.settle()

    def close(self):
        rear, hinge = self.present[:2]
        meeting = rear
        is_closed = [bool(side) and not side[0].is_open for side in self.sides]
        if not any(is_closed):
            self.sides[0].insert(0, Waiting(hinge, is_open=False))
        elif not is_closed[0]:
            meeting = hinge
        self.take(meeting)

    def take(self, meeting):
        while meeting is not None:
            self.refill()
            while not self.is_open(0) and not self.is_open(1):
                if not self.sides[0] or not self.sides[1]:
                    self.present = None
                    return
                meeting = self.sides[1].pop(0).far
                self.refill()
            if not self.is_open(0):
                self.turn()
            gate = self.sides[0].pop(0)
            self.present, self.last = [meeting, gate.far, gate.across, gate.owner], TAKEN
            self.refill()
            meeting = self.meet()

    def refill(self):
        for side, other in (self.sides, self.sides[::-1]):
            if not side and len(other) >= 2:
                gate = other.pop()
                gate.far = other[-1].far
                side.append(gate)

    def meet(self):
        rear, hinge = self.present[:2]
        if self.is_open(0) and self.sides[0][0].far == rear:
            self.sides[0].pop(0)
            return rear
        if self.is_open(1) and self.sides[1][0].far == hinge:
            self.sides[1].pop(0)
            return hinge
        return None

    def settle(self):
        self.refill()
        meeting = self.meet()
        if meeting is not None:
            self.take(meeting)
        elif self.joined >= 8:
            self.turn()
            self.last = OTHER

    def open_gates(self):
        if self.present is None:
            return []
        gates = [self.ends()]
        for side, near, forward in ((self.sides[0], self.present[1], self.forward),
                                    (self.sides[1], self.present[0], not self.forward)):
            for gate in side:
                if gate.is_open:
                    gates.append((near, gate.far) if forward else (gate.far, near))
                near = gate.far
        return gates


def follow_border(gates):
    """The vertices from which the gates start, in border order; some may be there more than once."""
    last_from = {start: i for i, (start, _) in enumerate(gates)}
    passed = set()
    border = []
    for gate in range(len(gates)):
        while gate is not None and gate not in passed:
            passed.add(gate)
            border.append(gates[gate][0])
            gate = last_from.get(gates[gate][1])
    return border


class Patch:
    """points, ids, wedges (the table, or None), triangles."""

    def __init__(self, arc, codec, data):
        self.points_count, self.wedges_count, self.triangles_count, self.shared = arc[3], arc[4], arc[2], arc[5]
        if codec == 0:
            self.read_raw(data)
        else:
            self.read_packed(codec, data)

    def read_raw(self, data):
        counts = struct.unpack_from("<4I", data)
        require(counts == (self.points_count, self.wedges_count, self.triangles_count, self.shared),
                "counts differ from the arc's")
        *self.corner, a, b, c, d, first = struct.unpack_from("<3i4BQ", data, 16)
        stream = Stream(data[40:])

        def numbers(count, width):
            raw = stream.take(count * width)
            return [int.from_bytes(raw[i:i + width], "little") for i in range(0, len(raw), width)]

        flat = numbers(3 * self.points_count, a)
        self.points = [tuple(self.corner[k] + flat[3 * i + k] for k in range(3)) for i in range(self.points_count)]
        self.ids = [(first + x) % 2**64 for x in numbers(self.shared, b)]
        self.wedges = numbers(self.wedges_count, c) if c else None
        flat = numbers(3 * self.triangles_count, d)
        self.triangles = [tuple(flat[3 * i:3 * i + 3]) for i in range(self.triangles_count)]
        require(stream.at == len(stream.data), "a geometry section of another length")

    def read_packed(self, codec, data):
        *self.corner, shift, has_table, near, zero, side_size, stored = struct.unpack_from("<3i4BII", data)
        require(near <= 1 and zero == 0, "a reserved byte is not 0")
        side = Stream(decompress(codec, data[24:24 + stored], side_size))
        steps = side.take(side.number())
        names = side.take(side.number())
        triangles, bases, border = self.read_triangles(int.from_bytes(steps, "little"), 8 * len(steps), names)
        wedge_points = self.read_wedges(side) if has_table else None
        wedge_bases = bases
        ids = self.read_ids(side, [wedge_points[w] for w in border] if has_table else border)
        coarse = bits(side.take((self.points_count + 7) // 8), self.points_count) if shift else None
        if has_table:
            first = {}
            for w, p in enumerate(wedge_points):
                first.setdefault(p, w)
            bases = {p: [wedge_points[x] for x in bases.get(w, [])] for p, w in first.items()}
        points = self.read_points(bases, shift, near, coarse, side, data[24 + stored:])
        require(side.at == len(side.data), "side bytes of another length")
        self.ids = [ids[p] for p in sorted(ids)]
        self.place(points, [p in ids for p in range(len(points))], wedge_points, triangles)
        self.wedge_bases = [wedge_bases.get(w, []) for w in range(self.wedges_count)]

    def read_triangles(self, steps, bits_left, names):
        triangles = []
        bases = {}  # of the vertices that were met: [], [a] or [rear, hinge, across]
        self.behind = []  # for each triangle, the one across the gate behind which it was found, or None
        reader = NameReader(names)
        front = Front()
        border_gates = []

        def name(basis):
            back = reader.get(NAME)
            require(back <= len(bases), "a name of no vertex")
            if back:
                return len(bases) - back
            bases[len(bases)] = basis
            return len(bases) - 1

        while len(triangles) < self.triangles_count:
            if front.present is None:
                t = []
                for _ in range(3):
                    t.append(name(t[-1:]))
                front.start(t, len(triangles))
                triangles.append(tuple(t))
                self.behind.append(None)
                continue
            ones = 0
            while steps & 1:
                steps >>= 1
                ones += 1
            steps >>= 1
            bits_left -= ones + 1
            require(bits_left >= 0, "the steps are too short")
            row = steps_of(front.is_open(0), front.is_open(1), front.last)
            require(ones < len(row), "an impossible step")
            step = row[ones]
            rear, hinge, across, owner = front.present
            start, end = front.ends()
            if step == NOTHING:
                border_gates.append((start, end))
                front.close()
                continue
            this = len(triangles)
            walk = 3 if step == SECOND else 0
            if step == NEW:
                third = len(bases)
                bases[third] = [rear, hinge, across]
            elif step in (AHEAD, BEHIND):
                third = front.sides[step == BEHIND][0].far
            else:
                if step == NAMED:
                    walk = reader.get(WALK)
                    require(walk <= 128, "a walk that is too long")
                third = front.walk(walk) if walk else len(bases) - reader.get(NAME)
            triangles.append((end, start, third))
            self.behind.append(owner)
            if step == AHEAD:
                front.join_ahead(this)
            elif step == BEHIND:
                front.join_behind(this)
            elif step == NAMED and walk and walk % 2 == 0:
                front.split_behind(third, this)
            else:
                front.split(third, this, NEW if step == NEW else OTHER)
        require(bits_left < 8 and steps == 0 and reader.is_at_end(), "the steps are too long")
        border_gates += front.open_gates()
        return triangles, bases, follow_border(border_gates)

    def read_wedges(self, side):
        points = []
        following = 0
        for _ in range(self.wedges_count):
            back = side.number()
            points.append(following - back)
            following += back == 0
        return points

    def read_ids(self, side, border):
        order = list(dict.fromkeys(border + list(range(self.points_count))))
        highs = [side.number() for _ in range(side.number())]
        for i in range(1, len(highs)):
            highs[i] = (highs[i] + highs[i - 1]) & MASK
        before = [0] * len(highs)
        ids = {}
        at = 0
        while len(ids) < self.shared:
            kind = side.number()
            run = order[at:at + side.number() + 1]
            at += len(run)
            if kind:
                high = (kind - 1) // 2
                low = before[high] + unzigzag(side.number())
                for i, point in enumerate(run):
                    before[high] = (low + (i if kind % 2 else -i)) & MASK
                    ids[point] = highs[high] << 32 | before[high]
        return ids

    def read_points(self, bases, shift, near, coarse, side, data):
        count = self.points_count
        blocks = [min(64, count - begin) for begin in range(0, count, 64)]
        parameters = side.take(3 * len(blocks))
        unary_sizes = [side.number(), side.number()]
        low_sizes = [low_size(blocks, parameters[axis * len(blocks):]) for axis in range(3)]
        unary_sizes.append(len(data) - sum(low_sizes) - sum(unary_sizes))
        bits = Stream(data)
        lows = [bits.take(size) for size in low_sizes]
        codes = [rice_codes(blocks, parameters[axis * len(blocks):], lows[axis], bits.take(unary_sizes[axis]))
                 for axis in range(3)]
        points = []
        for i in range(count):
            basis = bases.get(i, [])
            if len(basis) == 3:
                a, b, c = (points[p] for p in basis)
                expected = [a[k] + b[k] - c[k] - (signed(a[k] + b[k] - 2 * c[k]) >> 2) * near for k in range(3)]
            else:
                expected = points[basis[0]] if basis else points[-1] if points else self.corner
            place = []
            for k in range(3):
                difference = unzigzag(codes[k][i])
                if shift and coarse[i]:
                    rounded = signed(expected[k] + (1 << (shift - 1))) >> shift
                    place.append(signed((rounded + difference) << shift))
                else:
                    place.append(signed(expected[k] + difference))
            points.append(tuple(place))
        return points

    def place(self, points, is_shared, wedge_points, triangles):
        order = sorted(range(len(points)), key=lambda i: (1 - is_shared[i], i))
        place = [0] * len(points)
        for new, old in enumerate(order):
            place[old] = new
        self.points = [points[i] for i in order]
        self.wedges = None
        self.wedge_place = wedge_place = place
        if wedge_points is not None:
            wedge_order = sorted(range(len(wedge_points)), key=lambda w: (place[wedge_points[w]], w))
            wedge_place = [0] * len(wedge_points)
            for new, old in enumerate(wedge_order):
                wedge_place[old] = new
            self.wedge_place = wedge_place
            self.wedges = [place[wedge_points[w]] for w in wedge_order]
        self.triangles = [tuple(wedge_place[w] for w in t) for t in triangles]


def low_size(blocks, parameters):
    return sum((size * k + 7) // 8 for size, k in zip(blocks, parameters))


def rice_codes(blocks, parameters, low, unary):
    """The codes of blocks that have so many: their low bits, and what is above them in unary."""
    unary_bits = int.from_bytes(unary, "little")
    at = low_at = 0
    codes = []
    for size, k in zip(blocks, parameters):
        low_bytes = (size * k + 7) // 8
        lows = int.from_bytes(low[low_at:low_at + low_bytes], "little")
        low_at += low_bytes
        for i in range(size):
            zeros = 0
            while not unary_bits >> at & 1:
                require(at < 8 * len(unary), "the unary codes are too short")
                zeros += 1
                at += 1
            at += 1
            codes.append((zeros << k | lows >> (i * k) & ((1 << k) - 1)) & MASK)
    require(unary_bits >> at == 0 and len(unary) == (at + 7) // 8, "the unary codes are too long")
    return codes


def unpack_numbers(packed, before, components, size):
    """before: for each tuple one that precedes it, or None."""
    tuples = len(before)
    plane = tuples * components
    columns = []
    for c in range(components):
        columns.append([])
        for i in range(tuples):
            code = sum(packed[byte * plane + c * tuples + i] << (8 * byte) for byte in range(size))
            known = 0 if before[i] is None else columns[c][before[i]]
            columns[c].append((known + unzigzag(code, 8 * size)) & ((1 << 8 * size) - 1))
    return columns


def unpack_directions(data, bases):
    count = len(bases)
    *first, unary_size = struct.unpack_from("<HHI", data)
    blocks = [min(64, count - begin) for begin in range(0, count, 64)]
    parameters = data[8:8 + len(blocks)]
    stream = Stream(data[8 + len(blocks):])
    k = [[p & 15 for p in parameters], [p >> 4 for p in parameters]]
    lows = [stream.take(low_size(blocks, k[axis])) for axis in range(2)]
    unary = [stream.take(unary_size), b""]
    unary[1] = stream.take(len(stream.data) - stream.at)
    places = []
    for axis in range(2):
        codes = rice_codes(blocks, k[axis], lows[axis], unary[axis])
        known = []
        for i, basis in enumerate(bases):
            if len(basis) == 3:
                a, b, c = (known[w] for w in basis)
                expected = (3 * (a + b) - 2 * c + 2) >> 2
            else:
                expected = known[basis[0]] if basis else known[i - 1] if i else first[axis]
            known.append((expected + unzigzag(codes[i], 16)) & 0xFFFF)
        places.append(known)
    return [direction(a, b) for a, b in zip(*places)]


def single(x):
    return struct.unpack("<f", struct.pack("<f", x))[0]


ARC = [single(c) for c in (0.0177230909, -0.0785178393, 0.175562292, -0.329162508, 0.999793112)]
QUARTER = single(0.785398185)
NOTHING = 2.0**-100


def angle(y, x):
    a = abs(x)
    r = single(single(a - y) / single(single(a + y) + NOTHING))
    s = single(r * r)
    p = ARC[0]
    for c in ARC[1:]:
        p = single(c + single(s * p))
    p = single(QUARTER + single(r * p))
    return single(2 * QUARTER + (p if x < 0.0 else -p))


def normal_terms(corners):
    """What a triangle adds at each of its corners."""
    a, b, c = ([float(x) for x in corner] for corner in corners)
    u, v = ([q - p for p, q in zip(*pair)] for pair in ((a, b), (a, c)))
    w = [q - p for p, q in zip(u, v)]
    n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    n = [single(x * 2.0**-32) for x in n]
    length = single(math.sqrt(single(single(single(n[0] * n[0]) + single(n[1] * n[1])) + single(n[2] * n[2]))))
    inverse = single(1.0 / single(length + NOTHING))
    unit = [single(x * inverse) for x in n]

    def dot(p, q):
        return single((p[0] * q[0] + p[1] * q[1] + p[2] * q[2]) * 2.0**-32)

    weights = [single(2.0**17 * angle(length, d)) for d in (dot(u, v), -dot(u, w), dot(v, w))]
    return [[int(single(x * weight)) for x in unit] for weight in weights]


def expected_place(sums, half):
    x, y, z = (single(s) for s in sums)
    scale = single(half / single(single(single(abs(x) + abs(y)) + abs(z)) + NOTHING))
    p, q = single(x * scale), single(y * scale)
    if z < 0.0:
        outer = single(half - abs(q)), single(half - abs(p))
        p, q = (-outer[0] if p < 0.0 else outer[0]), (-outer[1] if q < 0.0 else outer[1])
    a, b = round(p), round(q)
    return (abs(a) if abs(b) == half else a), (abs(b) if abs(a) == half else b)


def turn(place, half):
    u, v = half - abs(place[1]), half - abs(place[0])
    return (-u if place[0] < 0 else u), (-v if place[1] < 0 else v)


def unpack_normals(data, patch):
    count = patch.wedges_count
    size, of_points, zero, unary_size = struct.unpack_from("<BBHI", data)
    require(6 <= size <= 16 and of_points <= 1 and zero == 0, "a section of normals begins wrong")
    half = 2**(size - 1) - 1
    points = patch.wedges or list(range(count))
    sums = [[0, 0, 0] for _ in range(count)]
    for t in patch.triangles:
        for w, term in zip(t, normal_terms([patch.points[points[w]] for w in t])):
            known = sums[points[w] if of_points else w]
            known[:] = [a + b for a, b in zip(known, term)]
    shared = sum(p < len(patch.ids) for p in points)
    blocks = [min(64, n - begin) for n in (shared, count - shared) for begin in range(0, n, 64)]
    parameters = data[8:8 + len(blocks)]
    block_of = [i for i, block in enumerate(blocks) for _ in range(block)]
    kept = [i for i, p in enumerate(parameters) if p != 255]
    stream = Stream(data[8 + len(blocks):])
    k = [[parameters[i] >> shift & 15 for i in kept] for shift in (0, 4)]
    require(all(p <= 14 for axis in k for p in axis), "a parameter is too large")
    kept_blocks = [blocks[i] for i in kept]
    lows = [stream.take(low_size(kept_blocks, k[axis])) for axis in range(2)]
    unary = [stream.take(unary_size), b""]
    unary[1] = stream.take(len(stream.data) - stream.at)
    codes = [iter(rice_codes(kept_blocks, k[axis], lows[axis], unary[axis])) for axis in range(2)]
    normals = []
    for w in range(count):
        place = expected = expected_place(sums[points[w] if of_points else w], half)
        if parameters[block_of[w]] != 255:
            outer = abs(expected[0]) + abs(expected[1]) > half
            begin = turn(expected, half) if outer else expected
            place = [((begin[axis] + half + unzigzag(next(codes[axis]), 16)) & 0xFFFF) - half for axis in range(2)]
            place = turn(place, half) if outer and max(abs(place[0]), abs(place[1])) <= half else place
        normals.append(direction(place[0] + half, place[1] + half, half))
    return normals


def direction(u, v, half=2047):
    if u > 2 * half or v > 2 * half:
        return (0.0, 0.0, 0.0)
    x = single((u - half) / half)
    y = single((v - half) / half)
    rest_x, rest_y = single(1.0 - abs(x)), single(1.0 - abs(y))
    z = single(rest_x - abs(y))
    if z < 0.0:
        x, y = math.copysign(rest_y, x), math.copysign(rest_x, y)
    squares = single(single(single(x * x) + single(y * y)) + single(z * z))
    length = single(math.sqrt(squares))
    return (single(x / length), single(y / length), single(z / length))


def read_column(array, arc, is_finest, patch, codec, data):
    of_cells = array.association == 1
    tuples = arc[2] if of_cells else arc[4]
    if not data and (array.role == 3 or (array.properties.get(b"levels") == FINEST and not is_finest)):
        return data
    if codec == 0:
        require(len(data) == tuples * array.tuple_size, "a column of another length")
        return data
    if codec == 3:
        require(array.role == 2 and not of_cells and array.tuple_size == 12, "normals where there are none")
        return b"".join(struct.pack("<3f", *normal) for normal in unpack_normals(data, patch))
    size = array.tuple_size // array.components
    if array.role == 2 and not of_cells and array.tuple_size == 12:
        values = [struct.pack("<3f", *d) for d in unpack_directions(data, patch.wedge_bases)]
    else:
        known = patch.behind if of_cells else [basis[0] if basis else None for basis in patch.wedge_bases]
        before = [i - 1 if b is None and i else b for i, b in enumerate(known)]
        before = [None] * tuples if array.role == 3 else before
        columns = unpack_numbers(decompress(codec, data, tuples * array.tuple_size), before, array.components, size)
        values = [b"".join(x.to_bytes(size, "little") for x in v) for v in zip(*columns)]
    if of_cells:
        return b"".join(values)
    placed = [b""] * tuples
    for w, value in enumerate(values):
        placed[patch.wedge_place[w]] = value
    return b"".join(placed)


def flatten(tuples):
    return [x for t in tuples for x in t]


FORMATS = {2: "b", 15: "b", 3: "B", 4: "h", 5: "H", 6: "i", 7: "I", 8: "q", 9: "Q", 10: "f", 11: "d", 12: "q", 16: "q",
           17: "Q"}


def extend_ranges(ranges, array, column):
    """Made normals are other ones when they come back, and exact points are no values."""
    if array.role in (2, 3):
        return
    values = [x for x, in struct.iter_unpack("<" + FORMATS[array.type], column)]
    for c, known in enumerate(ranges):
        own = [float(x) for x in values[c::array.components] if x == x]
        ranges[c] = (min([known[0]] + own), max([known[1]] + own))


def dump(model, out):
    ranges = [[(math.inf, -math.inf)] * array.components for array in model.arrays]
    for i, arc in enumerate(model.arcs):
        is_finest = model.refinement == 1 or arc[1] == len(model.nodes) - 1
        patch = Patch(arc, *model.section(i, 0))
        table = patch.wedges or []
        out.write(struct.pack("<4I", len(patch.points), len(patch.ids), len(table), len(patch.triangles)))
        out.write(struct.pack(f"<{3 * len(patch.points)}i", *flatten(patch.points)))
        out.write(struct.pack(f"<{len(patch.ids)}Q{len(table)}I", *patch.ids, *table))
        out.write(struct.pack(f"<{3 * len(patch.triangles)}I", *flatten(patch.triangles)))
        for j, array in enumerate(model.arrays):
            column = read_column(array, arc, is_finest, patch, *model.section(i, 1 + j))
            out.write(column)
            if is_finest:
                extend_ranges(ranges[j], array, column)
    for array, own in zip(model.arrays, ranges):
        require(array.role == 2 or array.ranges == own, f"the ranges of {array.name} are others")
    for i, blob in enumerate(model.blobs):
        out.write(model.get(blob[3], model.sections[i], f"blob {i}")[1])


def main():
    require(len(sys.argv) == 3, "usage: read_model.py MODEL.bmt DUMP")
    with open(sys.argv[1], "rb") as file:
        model = Model(file.read())
    with open(sys.argv[2], "wb") as out:
        dump(model, out)
    print(f"{len(model.arcs)} patches, {len(model.arrays)} arrays, {len(model.blobs)} blobs read")


if __name__ == "__main__":
    main()
