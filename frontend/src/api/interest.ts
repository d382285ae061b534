/** What the server sends only to tabs that display it: components register, the socket asks. */
export class Interest<Watcher> {
  readonly watchers = new Set<Watcher>();
  private onChange: (on: boolean) => void = () => undefined;

  /** For the socket: called for the first watcher and after the last one. */
  listen(listener: (on: boolean) => void): void {
    this.onChange = listener;
  }

  get wanted(): boolean {
    return this.watchers.size > 0;
  }

  /** Until the returned function is called. */
  watch(watcher: Watcher): () => void {
    this.watchers.add(watcher);
    if (this.watchers.size === 1) this.onChange(true);
    return () => {
      this.watchers.delete(watcher);
      if (this.watchers.size === 0) this.onChange(false);
    };
  }
}
