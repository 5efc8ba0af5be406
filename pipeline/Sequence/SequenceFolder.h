// The folder of a sequence: frames/0001, frames/0002, ... each as a single run writes it and complete from the moment
// it is there, with frame.json, what sequence.json will say of it; the latest one holds what the next frame needs of
// it, view_state.bin. One run at a time writes to a folder.
#pragma once

#include "Run/Run.h"

#include <string>
#include <vector>

namespace Drydock
{

class DRYDOCK_API FSequenceFolder
{
public:
	/** Makes the folder and keeps other runs out until it is destroyed; removes what a killed run left half done.
	 * NumDigits: of a frame's folder, at least. Throws FError (exit code 3): in use, or not to be written. */
	FSequenceFolder(const std::string& InPath, int InNumDigits);
	~FSequenceFolder();
	FSequenceFolder(const FSequenceFolder&) = delete;
	FSequenceFolder& operator=(const FSequenceFolder&) = delete;

	/** The frames that are there, ascending. */
	std::vector<int> FindFrames() const;

	/** "out/walk/frames/0003". */
	std::string GetFramePath(int Frame) const;

	/** Throws FError as WriteNewRunFolder. ViewState: empty, where it would not help. */
	void WriteFrame(int Frame, const FRunResult& Result, const std::string& FrameJson, const std::string& ViewState);

	std::string ReadFrameJson(int Frame) const;
	std::string ReadViewState(int Frame) const;
	std::string GetViewStatePath(int Frame) const;
	/** For only the latest frame's is of use. */
	void RemoveViewState(int Frame);

	/** Empty where there is none. */
	std::string ReadSequenceJson() const;
	void WriteSequenceJson(const std::string& Text);

	/** Removes the frames and sequence.json. */
	void Clear();

	const std::string& GetPath() const { return Path; }

private:
	void RemoveLeftovers();

	const std::string Path;
	const int NumDigits;
	int Lock = -1;
};

} // namespace Drydock
