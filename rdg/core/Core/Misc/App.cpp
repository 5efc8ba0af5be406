// The application's time and name, and the frame's number.
#include "Misc/App.h"

#include "CoreGlobals.h"
#include "Misc/Paths.h"

#include <filesystem>
#include <set>
#include <string>

uint32 GFrameNumber = 0;
uint32 GFrameNumberRenderThread = 0;
uint64 GFrameCounter = 0;
uint64 GFrameCounterRenderThread = 0;

double FApp::CurrentTime = 0.0;
double FApp::LastTime = 0.0;
double FApp::DeltaTime = 1.0 / 60.0;
double FApp::FixedDeltaTime = 1.0 / 30.0;

const TCHAR* FApp::GetProjectName()
{
	std::string Name;
	std::error_code Ignored;
	for (const auto& Entry : std::filesystem::directory_iterator(*FPaths::ProjectDir(), Ignored))
	{
		const bool bBefore = Name.empty() || Entry.path().stem().string() < Name;
		Name = Entry.path().extension() == ".uproject" && bBefore ? Entry.path().stem().string() : Name;
	}
	// Callers keep the pointer.
	static std::set<std::string> Kept;
	return Kept.insert(Name).first->c_str();
}
