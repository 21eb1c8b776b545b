"""Points at which a statement fails, and Drake's motions that veto a proof; nothing here proves."""
