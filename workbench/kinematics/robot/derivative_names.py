"""Names of the orders of derivatives."""

ORDERS = ("position", "velocity", "acceleration", "jerk", "snap")


def order_name(n: int) -> str:
    """The name of the n-th derivative of a position."""
    return ORDERS[n] if n < len(ORDERS) else f"derivative {n}"
