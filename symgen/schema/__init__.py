"""What a scene's text is made of, whatever it describes: names, quantities, expressions, and the errors about them."""
