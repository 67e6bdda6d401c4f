# Messages, services and actions of this package.
