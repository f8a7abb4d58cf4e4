"""Turns the bytes of the numbers of a binary MSH file round: python swap.py IN OUT

gmsh writes the byte order of its machine; this is for meshes of the other order.
Sections other than those of the mesh itself are copied as they are.
"""

import struct
import sys

NODES = {1: 2, 2: 3, 3: 4, 8: 3, 9: 6, 10: 9, 15: 1, 16: 8}


class Swap:
    def __init__(self, data):
        self.data, self.at, self.out = data, 0, bytearray()

    def text(self):
        """Copies a line; gives it."""
        end = self.data.index(b"\n", self.at) + 1
        line = self.data[self.at : end]
        self.out += line
        self.at = end
        return line.decode().strip()

    def take(self, form, count=1):
        """Turns `count` numbers of a format; gives them."""
        form = f"{count}{form}"
        values = struct.unpack_from("<" + form, self.data, self.at)
        self.out += struct.pack(">" + form, *values)
        self.at += struct.calcsize("<" + form)
        return values

    def run(self):
        while self.at < len(self.data):
            name = self.text()
            if name == "$MeshFormat":
                self.version = self.text().split()[0]
                self.take("i")
            elif name in ("$Entities", "$Nodes", "$ParametricNodes", "$Elements"):
                getattr(self, name[1:].lower() + self.version.replace(".", ""))()
            elif name.startswith("$") and not name.startswith("$End"):
                end = self.data.index(b"$End" + name[1:].encode(), self.at)
                self.out += self.data[self.at : end]
                self.at = end
        return bytes(self.out)

    def nodes22(self, parametric=False):
        for _ in range(int(self.text())):
            self.take("i")
            self.take("d", 3)
            if parametric:
                dimension, _ = self.take("i", 2)
                self.take("d", {1: 1, 2: 2}.get(dimension, 0))

    def parametricnodes22(self):
        self.nodes22(True)

    def elements22(self):
        left = int(self.text())
        while left > 0:
            kind, count, tags = self.take("i", 3)
            self.take("i", count * (1 + tags + NODES[kind]))
            left -= count

    def entities41(self):
        for dimension, count in enumerate(self.take("Q", 4)):
            for _ in range(count):
                self.take("i")
                self.take("d", 6 if dimension else 3)
                self.take("i", self.take("Q")[0])
                if dimension:
                    self.take("i", self.take("Q")[0])

    def nodes41(self):
        for _ in range(self.take("Q", 4)[0]):
            dimension, _, parametric = self.take("i", 3)
            (count,) = self.take("Q")
            self.take("Q", count)
            self.take("d", count * (3 + (dimension if parametric else 0)))

    def elements41(self):
        for _ in range(self.take("Q", 4)[0]):
            _, _, kind = self.take("i", 3)
            (count,) = self.take("Q")
            self.take("Q", count * (1 + NODES[kind]))


def swap(source, target):
    with open(source, "rb") as file:
        data = file.read()
    with open(target, "wb") as file:
        file.write(Swap(data).run())


if __name__ == "__main__":
    swap(sys.argv[1], sys.argv[2])
