/** What the server sends only to tabs that display it: components register, the socket asks. */
export class Interest<Watcher> {
  readonly watchers = new Set<Watcher>();
  private onChange: (on: boolean) => void = () => undefined;

  /** The socket's side: called when the first watcher comes and when the last one goes. */
  listen(listener: (on: boolean) => void): void {
    this.onChange = listener;
  }

  get wanted(): boolean {
    return this.watchers.size > 0;
  }

  /** Until what it returns is called. */
  watch(watcher: Watcher): () => void {
    this.watchers.add(watcher);
    if (this.watchers.size === 1) this.onChange(true);
    return () => {
      this.watchers.delete(watcher);
      if (this.watchers.size === 0) this.onChange(false);
    };
  }
}
