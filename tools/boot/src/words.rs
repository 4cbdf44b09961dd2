//! What is said of a firmware that is not on a board, in the two languages that the tools speak.
//!
//! Owns the words; `docs/flash.md` says more of each number.

unoclp_words::messages! {
    not_hex(line)
        "line {line} is not Intel HEX; name a firmware file that ends in .hex"
        "a linha {line} não é Intel HEX; indique um arquivo de firmware que termine em .hex";
    damaged(line)
        "line {line} is damaged: its check sum is wrong, or it is cut; fetch the file again"
        "a linha {line} está danificada: a soma de verificação não confere, ou falta um pedaço; baixe o arquivo de novo";
    cut_short()
        "the file ends before its last record; fetch it again"
        "o arquivo termina antes do último registro; baixe-o de novo";
    twice(address)
        "the file fills address {address} twice; build or fetch it again"
        "o arquivo preenche duas vezes o endereço {address}; gere-o ou baixe-o de novo";
    other_chip()
        "the file is not for the ATmega328P of an UNO or a Nano; build it for that chip"
        "o arquivo não é para o ATmega328P de um UNO ou Nano; gere-o para esse chip";
    too_large(bytes, room, model)
        "the file fills {bytes} bytes of flash, and the board {model} has room for {room}; take the firmware for that board"
        "o arquivo ocupa {bytes} bytes de flash, e na placa {model} cabem {room}; use o firmware para essa placa";
    silent()
        "no boot loader answers; is this the board's port, and is the kind of board right (uno, nano, nano-old)? If the board has no \
         automatic reset, press its reset button just as the writing begins"
        "nenhum bootloader responde; a porta é a da placa, e o tipo de placa está certo (uno, nano, nano-old)? Se a placa não tem \
         reset automático, aperte o botão de reset assim que a gravação começar";
    foreign()
        "something answers that is no boot loader; is this the board's port, and is the kind of board right (uno, nano, \
         nano-old)? Pull out whatever else uses D0 and D1"
        "o que responde não é um bootloader; a porta é a da placa, e o tipo de placa está certo (uno, nano, nano-old)? Desligue o que \
         mais usa D0 e D1";
    says_other_chip(signature)
        "the chip says that it is {signature}, and an ATmega328P says 1E 95 0F; this firmware does not run on that board"
        "o chip diz ser {signature}, e um ATmega328P diz 1E 95 0F; este firmware não roda nessa placa";
    broken_off()
        "the boot loader answers no more; check the cable, and try again"
        "o bootloader parou de responder; verifique o cabo e tente de novo";
    garbled()
        "the boot loader answered nonsense; check the cable and what is wired to D0 and D1, and try again"
        "o bootloader respondeu algo sem sentido; verifique o cabo e o que está ligado a D0 e D1, e tente de novo";
    differs(address, written, read)
        "at address {address} the flash holds {read}, and {written} was written; try again, with another cable if it happens \
         twice"
        "no endereço {address} a flash tem {read}, e foi gravado {written}; tente de novo, com outro cabo se acontecer duas \
         vezes";
    lost(why)
        "the port is gone: {why}; plug the board in again, and try again"
        "a porta não está mais disponível: {why}; ligue a placa de novo e tente de novo";
    untouched()
        "The board holds the firmware that it had"
        "A placa tem o firmware que tinha";
    without_firmware()
        "The board has no firmware now, and its outputs are off; its boot loader takes the next try"
        "A placa está sem firmware, com as saídas desligadas; o bootloader aceita a próxima tentativa";
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_message_says_the_same_in_both_languages() {
        assert_eq!(unoclp_words::gaps(super::ALL), [""; 0]);
    }
}
