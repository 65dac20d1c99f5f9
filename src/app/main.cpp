// The command actio.
#include "app/commands.hpp"

int main(int argc, char** argv) { return actio::app::command(argc, argv); }
