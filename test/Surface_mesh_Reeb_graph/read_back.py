#!/usr/bin/env python3
"""read_back.py TOOL: reads the files that the tool writes with Python's standard library alone.

A torus with an isolated vertex goes to the tool as OFF; the files that it writes are read by parsers that know nothing
of it, and must say the same about the same mesh and graph. The exit status is 0 if they do."""

import json
import math
import os
import re
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

SIZES = {'char': 'b', 'uchar': 'B', 'int8': 'b', 'uint8': 'B', 'short': 'h', 'ushort': 'H', 'int16': 'h',
         'uint16': 'H', 'int': 'i', 'uint': 'I', 'int32': 'i', 'uint32': 'I', 'float': 'f', 'float32': 'f',
         'double': 'd', 'float64': 'd'}


def torus(n, m):
    points = [((2 + math.cos(2 * math.pi * j / m)) * math.cos(2 * math.pi * i / n),
               (2 + math.cos(2 * math.pi * j / m)) * math.sin(2 * math.pi * i / n),
               math.sin(2 * math.pi * j / m)) for i in range(n) for j in range(m)]
    faces = []
    for i in range(n):
        for j in range(m):
            a, b = i * m + j, (i + 1) % n * m + j
            c, d = (i + 1) % n * m + (j + 1) % m, i * m + (j + 1) % m
            faces += [(a, b, c), (a, c, d)]
    return points, faces


def read_ply(data):
    header, data = data.split(b'end_header\n', 1)
    assert b'format binary_little_endian 1.0' in header
    elements = []
    for line in header.decode('ascii').splitlines():
        words = line.split()
        if words[0] == 'element':
            elements.append((words[1], int(words[2]), []))
        elif words[0] == 'property':
            elements[-1][2].append(words[1:])
    place = 0

    def number(kind):
        nonlocal place
        value, = struct.unpack_from('<' + SIZES[kind], data, place)
        place += struct.calcsize('<' + SIZES[kind])
        return value

    result = {}
    for name, count, properties in elements:
        result[name] = []
        for _ in range(count):
            row = {}
            for p in properties:
                if p[0] == 'list':
                    row[p[3]] = [number(p[2]) for _ in range(number(p[1]))]
                else:
                    row[p[1]] = number(p[0])
            result[name].append(row)
    assert place == len(data), 'bytes are left in the PLY file'
    return result


def read_vtp(text):
    root = ET.fromstring(text)
    assert root.tag == 'VTKFile' and root.get('type') == 'PolyData'
    piece = root.find('PolyData/Piece')

    def numbers(element):
        assert element.get('format') == 'ascii'
        return [float(word) for word in (element.text or '').split()]

    def array(path, name):
        return numbers(piece.find("%s/DataArray[@Name='%s']" % (path, name)))

    coordinates = numbers(piece.find('Points/DataArray'))
    offsets = [int(x) for x in array('Polys', 'offsets')]
    corners = [int(x) for x in array('Polys', 'connectivity')]
    assert len(coordinates) == 3 * int(piece.get('NumberOfPoints'))
    assert len(offsets) == int(piece.get('NumberOfPolys'))
    return ([tuple(coordinates[i:i + 3]) for i in range(0, len(coordinates), 3)],
            [tuple(corners[b:e]) for b, e in zip([0] + offsets[:-1], offsets)],
            array('PointData', 'value'), [int(x) for x in array('PointData', 'arc')])


def read_graphml(text):
    space = '{http://graphml.graphdrawing.org/xmlns}'
    root = ET.fromstring(text)
    names = {k.get('id'): k.get('attr.name') for k in root.iter(space + 'key')}

    def attributes(element):
        return {names[d.get('key')]: d.text for d in element.iter(space + 'data')}

    nodes = {n.get('id'): attributes(n) for n in root.iter(space + 'node')}
    edges = [(e.get('source'), e.get('target'), attributes(e)) for e in root.iter(space + 'edge')]
    return nodes, edges


def read_dot(text):
    assert re.match(r'\s*graph\b[^{]*\{', text) and text.rstrip().endswith('}')
    edges = re.findall(r'^\s*"?(\w+)"?\s*--\s*"?(\w+)"?', text, re.M)
    nodes = re.findall(r'^\s*"?(\w+)"?\s*\[[^\]]*mesh_vertex="?(\d+)', text, re.M)
    return dict(nodes), edges


def main(tool):
    points, faces = torus(20, 9)
    points.append((9, 9, 9))
    with tempfile.TemporaryDirectory() as folder:
        mesh, prefix = os.path.join(folder, 'mesh.off'), os.path.join(folder, 'result')
        with open(mesh, 'w') as out:
            out.write('OFF\n%d %d 0\n' % (len(points), len(faces)))
            out.writelines('%.17g %.17g %.17g\n' % p for p in points)
            out.writelines('3 %d %d %d\n' % f for f in faces)
        report = json.loads(subprocess.run(
            [tool, mesh, '--function', 'height', '--axis', '1,0.3,0.1', '--output', prefix, '--report', 'json',
             '--diagram', prefix + '.pers'],
            check=True, stdout=subprocess.PIPE).stdout)

        def content(end):
            with open(prefix + end, 'rb') as file:
                return file.read()

        values = [float(line) for line in content('.values.txt').split()]
        ply = read_ply(content('.ply'))
        vtp = read_vtp(content('.vtp').decode('utf8'))
        nodes, edges = read_graphml(content('.graphml').decode('utf8'))
        dot_nodes, dot_edges = read_dot(content('.dot').decode('utf8'))
        polylines = [[float(word) for word in line.split()] for line in content('.polylines.txt').splitlines()]
        diagram = [[float(word) for word in line.split()]
                   for line in content('.pers').decode('utf8').splitlines() if not line.startswith('#')]

    length = math.sqrt(1 + 0.09 + 0.01)
    assert len(values) == len(points)
    for value, p in zip(values, points):
        assert abs(value - (p[0] + 0.3 * p[1] + 0.1 * p[2]) / length) < 1e-12

    assert [(v['x'], v['y'], v['z']) for v in ply['vertex']] == points
    assert [v['v:value' if 'v:value' in v else 'value'] for v in ply['vertex']] == values
    face_property = next(name for name in ply['face'][0] if name.startswith('vertex_ind'))
    rotations = [{f[i:] + f[:i] for i in range(3)} for f in faces]
    assert all(tuple(f[face_property]) in r for f, r in zip(ply['face'], rotations))
    assert len(ply['face']) == len(faces)

    vtp_points, vtp_faces, vtp_values, vtp_arcs = vtp
    assert vtp_points == points and vtp_values == values
    assert len(vtp_faces) == len(faces) and all(f in r for f, r in zip(vtp_faces, rotations))
    assert set(vtp_arcs) == set(range(-1, report['arcs'])) and vtp_arcs.index(-1) == len(points) - 1

    assert len(nodes) == len(dot_nodes) == report['nodes'] and len(edges) == len(dot_edges) == report['arcs']
    for node in nodes.values():
        v = int(node['mesh_vertex'])
        assert float(node['value']) == values[v]
        assert (float(node['x']), float(node['y']), float(node['z'])) == points[v]
    assert sorted(int(n['mesh_vertex']) for n in nodes.values()) == sorted(int(v) for v in dot_nodes.values())
    ends = sorted(tuple(sorted(int(nodes[n]['mesh_vertex']) for n in e[:2])) for e in edges)
    assert ends == sorted(tuple(sorted(int(dot_nodes[n]) for n in e)) for e in dot_edges)

    # a line for every arc, from node to node: extrema are where their vertices are, and a node that
    # several arcs share is one point
    places = {}
    assert len(polylines) == len(edges)
    for line, edge in zip(polylines, edges):
        assert len(line) == 1 + 3 * line[0]
        lower, upper = sorted(edge[:2], key=lambda n: float(nodes[n]['value']))
        for n, i in ((lower, 1), (upper, len(line) - 3)):
            place = tuple(line[i:i + 3])
            assert places.setdefault(n, place) == place
            if nodes[n]['type'] in ('minimum', 'maximum'):
                assert place == points[int(nodes[n]['mesh_vertex'])]

    node_values = [float(n['value']) for n in nodes.values()]
    assert 2 * len(diagram) == sum(n['type'] != 'isolated' for n in nodes.values()) + 2 * report['degenerate']
    assert all(min(node_values) <= x <= max(node_values) for row in diagram for x in row[1:])


main(sys.argv[1])
