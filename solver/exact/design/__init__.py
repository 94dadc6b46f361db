"""State feedback, observers, tracking and model matching: the poles wanted and the gains that give them."""
