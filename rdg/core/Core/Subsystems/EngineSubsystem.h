// Subsystems of the engine: made once, before FCoreDelegates::OnPostEngineInit. Source: engine
// Subsystems/EngineSubsystem.h.
#pragma once

#include "Subsystems/Subsystem.h"

class DRYDOCK_API UEngineSubsystem : public USubsystem
{
public:
	DRYDOCK_CLASS(UEngineSubsystem, USubsystem)
	using USubsystem::USubsystem;

	static constexpr Drydock::ESubsystemKind SubsystemKind = Drydock::ESubsystemKind::Engine;
};
