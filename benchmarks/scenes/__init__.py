"""Scenes that schemes and sizes are measured on, and the hard suite: scenes and starts from smooth to very stiff."""
