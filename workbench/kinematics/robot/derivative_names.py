"""Names of the orders of derivatives."""

ORDERS = ("position", "velocity", "acceleration", "jerk", "snap")


def per_second(n: int) -> str:
    """Returns the unit of the n-th time derivative over that of the quantity: "", "/s", "/s^2", …"""
    return ("", "/s")[n] if n < 2 else f"/s^{n}"


def order_name(n: int) -> str:
    """Returns the name of the n-th derivative of a position."""
    return ORDERS[n] if n < len(ORDERS) else f"derivative {n}"
