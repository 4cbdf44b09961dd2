//! What is said of a firmware that is not on a board, in the two languages that the tools speak.
//!
//! Owns the words; `docs/flash.md` says more of each number.

unoclp_words::messages! {
    not_hex(line)
        "line {line} is not Intel HEX; name a firmware file that ends in .hex"
        "a linha {line} não é Intel HEX; indique um arquivo de firmware que termine em .hex";
    damaged(line)
        "line {line} is damaged: its checksum is wrong, or part of it is missing; download the file again"
        "a linha {line} está danificada: a soma de verificação não confere, ou falta um pedaço; baixe o arquivo de novo";
    cut_short()
        "the file ends before its last record; download it again"
        "o arquivo termina antes do último registro; baixe-o de novo";
    twice(address)
        "the file sets address {address} twice; build or download it again"
        "o arquivo preenche duas vezes o endereço {address}; gere-o ou baixe-o de novo";
    other_chip(chip, boards, board)
        "the file is not for the {chip} ({boards}); use the firmware for the board {board}"
        "o arquivo não é para o {chip} ({boards}); use o firmware para a placa {board}";
    too_large(bytes, room, model)
        "the file takes {bytes} bytes of flash, but the board {model} has room for only {room}; use the firmware for that board"
        "o arquivo ocupa {bytes} bytes de flash, mas na placa {model} cabem só {room}; use o firmware para essa placa";
    silent(models)
        "no boot loader answers. Is this the board's port, and is the board type right ({models})? If the board has no \
         automatic reset, press its reset button when writing starts"
        "nenhum bootloader responde. A porta é a da placa, e o tipo de placa está certo ({models})? Se a placa não tem \
         reset automático, aperte o botão de reset assim que a gravação começar";
    foreign(models)
        "the device that answers is not a boot loader. Is this the board's port, and is the board type right ({models})? \
         Disconnect everything else from D0 and D1"
        "o dispositivo que responde não é um bootloader. A porta é a da placa, e o tipo de placa está certo ({models})? Desconecte \
         tudo o que estiver ligado a D0 e D1";
    says_other_chip(signature, chip, wanted)
        "the chip's signature is {signature}, but that of an {chip} is {wanted}; this firmware does not run on that board"
        "a assinatura do chip é {signature}, mas a de um {chip} é {wanted}; este firmware não roda nessa placa";
    broken_off()
        "the boot loader stopped answering; check the cable and try again"
        "o bootloader parou de responder; verifique o cabo e tente de novo";
    garbled()
        "the boot loader's answer makes no sense; check the cable and the wiring of D0 and D1, then try again"
        "a resposta do bootloader não faz sentido; verifique o cabo e o que está ligado a D0 e D1 e tente de novo";
    differs(address, written, read)
        "at address {address} the flash holds {read}, but {written} was written; try again. If it happens twice, use another \
         cable"
        "no endereço {address} a flash tem {read}, mas foi gravado {written}; tente de novo. Se acontecer duas vezes, troque o \
         cabo";
    lost(why)
        "the port has disappeared: {why}; plug the board in again and retry"
        "a porta não está mais disponível: {why}; reconecte a placa e tente de novo";
    untouched()
        "The board still has its old firmware"
        "A placa ainda tem o firmware antigo";
    without_firmware()
        "The board has no firmware now, and its outputs are off; its boot loader still works, so try again"
        "A placa está sem firmware, com as saídas desligadas; o bootloader ainda funciona: tente de novo";
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_message_says_the_same_in_both_languages() {
        assert_eq!(unoclp_words::gaps(super::ALL), [""; 0]);
    }
}
