// A value that others follow.

export class Signal<T> {
  private readonly followers = new Set<(value: T) => void>();

  constructor(private current: T) {}

  get value(): T {
    return this.current;
  }

  set value(value: T) {
    if (Object.is(value, this.current)) return;
    this.current = value;
    for (const follow of [...this.followers]) follow(value);
  }

  /** Has it followed: with what it is now, and with each change. */
  follow(follow: (value: T) => void): void {
    this.followers.add(follow);
    follow(this.current);
  }
}
