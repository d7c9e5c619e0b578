"""What happens to bytes on the way: single bits, several, bursts, bytes that are lost, doubled or put in."""

from __future__ import annotations

from random import Random

from benchmarks.reliability.proxy import Change


def flip(position: int) -> Change:
    """Flip one bit, counted from the first of the message; nothing where the message is shorter."""

    def change(message: bytes) -> bytes:
        if position >= 8 * len(message):
            return message
        changed = bytearray(message)
        changed[position // 8] ^= 1 << position % 8
        return bytes(changed)

    return change


def flip_some(random: Random, bits: int) -> Change:
    """Flip that many bits anywhere."""

    def change(message: bytes) -> bytes:
        changed = bytearray(message)
        for place in random.sample(range(8 * len(message)), min(bits, 8 * len(message))):
            changed[place // 8] ^= 1 << place % 8
        return bytes(changed)

    return change


def burst(random: Random, bits: int = 32) -> Change:
    """Replace up to that many bits in a row by others."""

    def change(message: bytes) -> bytes:
        start = random.randrange(8 * len(message))
        pattern = random.getrandbits(bits) | 1
        number = int.from_bytes(message, "big") ^ (pattern << start)
        return (number & (1 << 8 * len(message)) - 1).to_bytes(len(message), "big")

    return change


def lose(random: Random) -> Change:
    """Lose some bytes."""

    def change(message: bytes) -> bytes:
        start = random.randrange(len(message))
        return message[:start] + message[start + random.randrange(1, 64) :]

    return change


def double(random: Random) -> Change:
    """Pass some bytes on twice."""

    def change(message: bytes) -> bytes:
        start = random.randrange(len(message))
        stop = start + random.randrange(1, 64)
        return message[:stop] + message[start:]

    return change


def put_in(random: Random) -> Change:
    """Put foreign bytes in."""

    def change(message: bytes) -> bytes:
        start = random.randrange(len(message) + 1)
        return message[:start] + random.randbytes(random.randrange(1, 16)) + message[start:]

    return change


def exchange_blocks(random: Random, size: int = 64) -> Change:
    """Exchange two blocks, as a bad page or a bad reassembly would: their sum stays the same."""

    def change(message: bytes) -> bytes:
        if len(message) < 2 * size:
            return message
        first, second = sorted(random.sample(range(len(message) // size), 2))
        blocks = [message[size * index : size * (index + 1)] for index in range(-(-len(message) // size))]
        blocks[first], blocks[second] = blocks[second], blocks[first]
        return b"".join(blocks)

    return change
