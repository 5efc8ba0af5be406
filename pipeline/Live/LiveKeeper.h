// Two processes: one keeps the other, which runs the frames, and starts it again when the code of a plugin has crashed
// it. State that outlives a crash lies in files of a folder that both know.
#pragma once

#include "Live/EditHistory.h"

#include <optional>
#include <string>

namespace Drydock
{

/** State that outlived a crash; as it is by default: there was none. */
struct FLiveBefore
{
	int Port = 0;
	std::string Token;
	std::optional<FEditHistory> History; // of the last frame that was well
	std::string Crash;                   // the last line that the crash left on stderr
};

/** The folder's name in the environment; null: this process is the one that keeps. */
const char* FindLiveFolder();

/** For the kept one, which from here on does not outlive the one that keeps it. */
FLiveBefore BeginKept(const std::string& Folder);

/** The server's address, and a state whose frame was well, for the next one. */
void KeepAddress(const std::string& Folder, int Port, const std::string& Token);
void KeepHistory(const std::string& Folder, const FEditHistory& History);

/** Runs this program again with the same arguments, and once more after each crash that came after a frame which was
 * well. Returns its exit code. Throws FError where it cannot be started. */
int KeepLive();

} // namespace Drydock
