"""The gallery: pictures and facts of every shipped example, made by ``make gallery``."""
