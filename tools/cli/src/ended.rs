//! Who ends the gateway: Ctrl-C, and what stops a service.

/// Comes once somebody wants the gateway to end.
pub async fn asked() {
    #[cfg(unix)]
    {
        use tokio::signal::unix::{SignalKind, signal};
        let heard = (
            signal(SignalKind::interrupt()),
            signal(SignalKind::terminate()),
        );
        if let (Ok(mut interrupt), Ok(mut terminate)) = heard {
            tokio::select! {
                _ = interrupt.recv() => {}
                _ = terminate.recv() => {}
            }
            return;
        }
    }
    // Without it, the system ends the gateway as it ends others.
    if tokio::signal::ctrl_c().await.is_err() {
        std::future::pending().await
    }
}

/// From now on another Ctrl-C ends it at once: it is told that it takes long.
pub fn at_once() {
    use signal_hook::consts::{SIGINT, SIGTERM};
    let always = std::sync::Arc::new(std::sync::atomic::AtomicBool::new(true));
    for signal in [SIGINT, SIGTERM] {
        // Where the system does not let it, one waits.
        let _ = signal_hook::flag::register_conditional_shutdown(signal, 130, always.clone());
    }
}
