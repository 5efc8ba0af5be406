// The program called at a terminal of a given width.
#pragma once

#include "ProgramTestUtils.h"

#include <pty.h>

#include <cstdlib>

namespace ProgramTest
{

/** Arguments and variables of the environment as a shell takes them; both streams are the terminal, of Columns. */
inline FOutcome CallAtTerminal(
	const FProgramFolder& Folder, int Columns, const std::string& Arguments, const std::string& Variables = "")
{
	winsize Size = {};
	Size.ws_row = 50;
	Size.ws_col = static_cast<unsigned short>(Columns);
	int Terminal = -1;
	const pid_t Child = forkpty(&Terminal, nullptr, nullptr, &Size);
	if (Child == 0)
	{
		unsetenv("COLUMNS");
		setenv("NO_COLOR", "1", 1);
		const std::string Command = "cd '" + Folder.Path.string() + "' && " + Variables +
									" exec '" DRYDOCK_TEST_BINARY_DIR "/bin/drydock' " + Arguments;
		execl("/bin/sh", "sh", "-c", Command.c_str(), nullptr);
		_exit(127);
	}
	FOutcome Outcome;
	std::array<char, 4096> Buffer;
	for (ssize_t NumRead; (NumRead = read(Terminal, Buffer.data(), Buffer.size())) > 0;)
	{
		Outcome.Printed.append(Buffer.data(), static_cast<size_t>(NumRead));
	}
	int Status = 0;
	waitpid(Child, &Status, 0);
	Outcome.ExitCode = WIFEXITED(Status) ? WEXITSTATUS(Status) : -1;
	close(Terminal);
	return Outcome;
}

/** Lines as they stand on the screen for a moment at least: a bar of progress is one. Without escape sequences. */
inline std::vector<std::string> GetScreenLines(const std::string& Printed)
{
	std::vector<std::string> Lines = {""};
	for (size_t At = 0; At < Printed.size(); ++At)
	{
		if (Printed[At] == '\x1b')
		{
			At = Printed.find_first_of("mK", At);
			if (At == std::string::npos)
			{
				break;
			}
		}
		else if (Printed[At] == '\n' || Printed[At] == '\r')
		{
			Lines.emplace_back();
		}
		else
		{
			Lines.back() += Printed[At];
		}
	}
	return Lines;
}

} // namespace ProgramTest
