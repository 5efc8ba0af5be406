// Subsystems of the game: there is one game, which starts when the world does. Source: engine
// Subsystems/GameInstanceSubsystem.h.
#pragma once

#include "Subsystems/Subsystem.h"

class DRYDOCK_API UGameInstanceSubsystem : public USubsystem
{
public:
	DRYDOCK_CLASS(UGameInstanceSubsystem, USubsystem)
	using USubsystem::USubsystem;

	static constexpr Drydock::ESubsystemKind SubsystemKind = Drydock::ESubsystemKind::GameInstance;
};
